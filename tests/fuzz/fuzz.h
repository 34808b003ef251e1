/* Fuzz targets: each takes arbitrary bytes as one input, uses the code under test like a normal
 * caller, and aborts if an invariant fails. Crashes, leaks and undefined behaviour are for the
 * sanitizers to find. The same functions run under libFuzzer (`make fuzz`) and, on kept and on
 * freshly mutated inputs, in the ordinary tests (test_fuzz.c). */
#ifndef GLINT_TESTS_FUZZ_FUZZ_H
#define GLINT_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "render/mesh.h"

/* Each returns 0, as libFuzzer wants. */
typedef int fuzz_target(const uint8_t *bytes, size_t count);

fuzz_target fuzz_mesh;   /* a line with a file name's ending, then the file: import, then frames */
fuzz_target fuzz_scene;  /* what assimp could return, damaged in every way: frames */
fuzz_target fuzz_eval;   /* a line of options, then standard input of `glint eval` */
fuzz_target fuzz_divide; /* the same for `glint divide` */
fuzz_target fuzz_render; /* a line of options of `glint render`: read, not carried out */
fuzz_target fuzz_png;    /* a picture: read, written, read again, compared */
fuzz_target fuzz_packet; /* failure.json of a packet: read, written, read again, played */

/* Aborts with a message unless it holds. */
#define FUZZ_EXPECT(condition) fuzz_expect((condition), #condition, __FILE__, __LINE__)
void fuzz_expect(int condition, const char *text, const char *file, int line);

/* A file of this process's own that is removed when it exits. The last result stays valid. */
const char *fuzz_scratch(const char *name);

/* Writes bytes into such a file and returns its path. */
const char *fuzz_write(const char *name, const uint8_t *bytes, size_t count);

/* Splits an input behind its first line, which is copied into line with NUL at its end, cut to
 * size - 1 bytes; returns how many bytes of the input it took. */
size_t fuzz_first_line(const uint8_t *bytes, size_t count, char *line, size_t size);

/* The next byte of an input that is used up from its front; 0 when nothing is left. */
uint8_t fuzz_take(const uint8_t **bytes, size_t *count);

/* Checks the guarantees of mesh.h, then renders a small frame with a shading and a viewpoint chosen
 * by `view`: one thread and three must agree. */
void fuzz_draw(const glint_mesh *mesh, uint32_t view);

/* Runs a subcommand as main() does: argv from the words of a line, the bytes on standard input. */
typedef struct fuzz_run {
    int status;
    char *out, *err;
} fuzz_run;

fuzz_run fuzz_command(int (*command)(int argc, char **argv), const char *name, char *options,
                      const uint8_t *bytes, size_t count);
void fuzz_forget(fuzz_run *done);

/* A command must print nothing, or one line "glint NAME: …" without control characters; its exit
 * status must be 0, or 2 with such a line. */
void fuzz_expect_outcome(const fuzz_run *done, const char *name);

#endif
