/* Letters by FreeType; see text.h. */
#include "image/text.h"

#include <stdlib.h>

#include <ft2build.h>
#include FT_FREETYPE_H

#define FONT "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"

/* Of a line's height: how high the letters are, and how far below its top they stand. */
#define LETTERS  0.78
#define BASELINE 0.76

struct glint_text {
    FT_Library library;
    FT_Face face;
    int baseline;
};

glint_text *glint_text_open(int height)
{
    glint_text *text = calloc(1, sizeof *text);
    if (text == NULL || FT_Init_FreeType(&text->library) != 0) {
        free(text);
        return NULL;
    }
    if (FT_New_Face(text->library, FONT, 0, &text->face) != 0 ||
        FT_Set_Pixel_Sizes(text->face, 0, (FT_UInt)(LETTERS * height)) != 0) {
        glint_text_close(text);
        return NULL;
    }
    text->baseline = (int)(BASELINE * height);
    return text;
}

void glint_text_close(glint_text *text)
{
    if (text != NULL) {
        FT_Done_FreeType(text->library); /* and its faces */
        free(text);
    }
}

static void blend(glint_image *image, int x, int y, int end, uint8_t grey, unsigned cover)
{
    if (x < 0 || y < 0 || x >= image->width || x >= end || y >= image->height)
        return;
    uint8_t *rgb = &image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x)];
    for (int c = 0; c < 3; c++)
        rgb[c] = (uint8_t)((rgb[c] * (255 - cover) + grey * cover + 127) / 255);
}

static void draw_letter(FT_GlyphSlot glyph, glint_image *image, int x, int y, int end, uint8_t grey)
{
    for (unsigned row = 0; row < glyph->bitmap.rows; row++) {
        const uint8_t *cover = glyph->bitmap.buffer + (ptrdiff_t)row * glyph->bitmap.pitch;
        for (unsigned column = 0; column < glyph->bitmap.width; column++) {
            blend(image, x + glyph->bitmap_left + (int)column, y - glyph->bitmap_top + (int)row,
                  end, grey, cover[column]);
        }
    }
}

void glint_text_draw(glint_text *text, glint_image *image, int x, int y, int end, uint8_t grey,
                     const char *line)
{
    for (; *line != '\0'; line++) {
        if (FT_Load_Char(text->face, (FT_ULong)(unsigned char)*line, FT_LOAD_RENDER) == 0) {
            draw_letter(text->face->glyph, image, x, y + text->baseline, end, grey);
            x += (int)(text->face->glyph->advance.x >> 6);
        }
    }
}
