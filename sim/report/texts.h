/* The text of the report, text/NAME.md, and drawings of docs/images, as lines; the last one NULL.
 */
#ifndef GLINT_SIM_REPORT_TEXTS_H
#define GLINT_SIM_REPORT_TEXTS_H

extern const char *const glint_text_head[], *const glint_text_summary[], *const glint_text_claims[];
extern const char *const glint_text_device[], *const glint_text_lobes[];
extern const char *const glint_text_divider[], *const glint_text_energy[];
extern const char *const glint_text_frames[], *const glint_text_speed[];
extern const char *const glint_text_rasterizers[];
extern const char *const glint_text_units[], *const glint_text_trace[];

/* What `make compare` measured: docs/compare.csv. */
extern const char *const glint_text_compare[];

/* SVG: the device as in figure 3.1 and as it works; the divider of figure 2.13. */
extern const char *const glint_drawing_device_drawn[], *const glint_drawing_device[],
                                                           *const glint_drawing_divider[];

#endif
