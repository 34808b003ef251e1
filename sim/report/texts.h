/* The text of the report, text/NAME.md, as lines; the last one NULL. */
#ifndef GLINT_SIM_REPORT_TEXTS_H
#define GLINT_SIM_REPORT_TEXTS_H

extern const char *const glint_text_head[], *const glint_text_summary[], *const glint_text_claims[];
extern const char *const glint_text_device[],
    *const glint_text_lobes[], *const glint_text_divider[], *const glint_text_energy[],
                                                                *const glint_text_frames[],
                                                                    *const glint_text_speed[],
                                                                        *const glint_text_rest[];

#endif
