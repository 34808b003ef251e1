/* A failure as a directory: what a person reads, what a waveform viewer opens, and what `glint
 * replay` needs. */
#ifndef GLINT_SIM_FAILURE_PACKET_H
#define GLINT_SIM_FAILURE_PACKET_H

#include "failure/failure.h"
#include "image/image.h"

#define GLINT_PACKET_REPORT     "report.txt"
#define GLINT_PACKET_DATA       "failure.json"
#define GLINT_PACKET_WAVE       "wave.vcd"
#define GLINT_PACKET_SAVE_FILE  "wave.gtkw"
#define GLINT_PACKET_MODEL      "model.png" /* of a frame: the surroundings of the pixel */
#define GLINT_PACKET_RTL        "rtl.png"
#define GLINT_PACKET_DIFFERENCE "difference.png"

#define GLINT_PACKET_OLD_WAVE "wave.fst" /* a file of a packet too: older versions wrote it */

/* The two frames of a failure, for the pictures. */
typedef struct glint_packet_frames {
    const glint_image *model, *rtl;
} glint_packet_frames;

/* Writes the packet, and plays the failure where it has no capture yet: under another name beside
 * `directory`, which it takes when it is complete. The directories above are made if missing; an
 * older packet of that name is replaced, but not a directory with anything else in it. frames: NULL
 * for none. */
glint_status glint_packet_write(const glint_failure *failure, const glint_packet_frames *frames,
                                const char *directory, glint_error *err);

/* Reads a packet's failure. extra: a circuit besides Glint's own that it may be of; NULL: none.
 * setting.verilog is NULL: where its Verilog was is in failure->rtl, to be told. A packet may come
 * from anywhere: nothing that it names is opened, as a circuit's sources are run.
 * GLINT_IO_ERROR when it cannot be read; GLINT_BAD_INPUT, naming the file and what is wrong in it,
 * when it is no packet, is of no circuit that is known, or holds a value out of its range. */
glint_status glint_packet_read(const char *directory, const glint_circuit *extra,
                               glint_failure **failure, glint_error *err);

#endif
