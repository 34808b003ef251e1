/* A failure as a directory: a report to read, a waveform to view, and what `glint replay` needs. */
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

/* Writes the packet, replaying the failure first if it has no capture yet. It is written under a
 * temporary name next to `directory` and renamed when complete. Missing parent directories are
 * created; an older packet of that name is replaced, but not a directory containing anything else.
 * frames: NULL for none. */
glint_status glint_packet_write(const glint_failure *failure, const glint_packet_frames *frames,
                                const char *directory, glint_error *err);

/* Reads a packet's failure. extra: a circuit besides Glint's own that it may be of; NULL: none.
 * setting.verilog is NULL: failure->rtl names the Verilog's directory, for messages only. A packet
 * may come from anywhere and a circuit's sources are executed, so nothing that it names is opened.
 * GLINT_IO_ERROR if it cannot be read; GLINT_BAD_INPUT, naming the file and the fault, if it is not
 * a packet, belongs to an unknown circuit, or has a value out of range. */
glint_status glint_packet_read(const char *directory, const glint_circuit *extra,
                               glint_failure **failure, glint_error *err);

#endif
