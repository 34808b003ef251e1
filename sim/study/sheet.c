/* Pictures in rows and columns; see sheet.h. */
#include "study/sheet.h"

#include <stdlib.h>
#include <string.h>

#include "image/text.h"

#define MARGIN     10
#define LINE       16
#define LABEL      (2 * LINE + 4)
#define CELL_WIDTH 330 /* at least: the words need it */

static const uint8_t background[3] = {27, 31, 36};

struct glint_sheet {
    glint_image *image;
    glint_text *text; /* NULL: no font */
    int width, height, shrink;
    int cell_width; /* with the space that words need */
};

static int shrunk(int side, int shrink)
{
    return (side + shrink - 1) / shrink;
}

static int cell_width(int width, int shrink)
{
    const int picture = shrunk(width, shrink);
    return picture > CELL_WIDTH ? picture : CELL_WIDTH;
}

static int64_t sheet_width(int columns, int width, int shrink)
{
    return MARGIN + (int64_t)columns * (cell_width(width, shrink) + MARGIN);
}

static int64_t sheet_height(int rows, int height, int shrink)
{
    return MARGIN + (int64_t)rows * (LABEL + shrunk(height, shrink) + MARGIN) + LINE + MARGIN;
}

int glint_sheet_shrink_for(int rows, int columns, int width, int height, int max_width)
{
    int shrink = 1;
    while (shrink < width && (sheet_width(columns, width, shrink) > max_width ||
                              sheet_height(rows, height, shrink) > GLINT_IMAGE_SIDE_MAX))
        shrink++;
    return shrink;
}

/* The page, empty but for the note. */
static glint_status create_page(glint_sheet *sheet, int64_t width, int64_t height, const char *note,
                                glint_error *err)
{
    const glint_status status = glint_image_create((int)width, (int)height, &sheet->image, err);
    if (status != GLINT_OK)
        return status;
    const size_t pixels = (size_t)(width * height);
    for (size_t i = 0; i < pixels; i++)
        memcpy(&sheet->image->rgb[3 * i], background, 3);
    memset(sheet->image->object, 1, pixels);
    if (sheet->text != NULL) {
        glint_text_draw(sheet->text, sheet->image, MARGIN, (int)height - MARGIN - LINE, (int)width,
                        170, note);
    }
    return GLINT_OK;
}

glint_status glint_sheet_create(int rows, int columns, int width, int height, int shrink,
                                const char *note, glint_sheet **sheet, glint_error *err)
{
    *sheet = NULL;
    const int64_t page_width = sheet_width(columns, width, shrink);
    const int64_t page_height = sheet_height(rows, height, shrink);
    if (page_width > GLINT_IMAGE_SIDE_MAX || page_height > GLINT_IMAGE_SIDE_MAX) {
        return glint_fail(
            err, GLINT_BAD_ARGUMENT,
            "a sheet of %d rows would be %lld by %lld pixels: each side may be at most %d", rows,
            (long long)page_width, (long long)page_height, GLINT_IMAGE_SIDE_MAX);
    }
    glint_sheet *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a sheet");
    created->width = width;
    created->height = height;
    created->shrink = shrink;
    created->cell_width = cell_width(width, shrink);
    created->text = glint_text_open(LINE);
    const glint_status status = create_page(created, page_width, page_height, note, err);
    if (status != GLINT_OK) {
        glint_sheet_destroy(created);
        return status;
    }
    *sheet = created;
    return GLINT_OK;
}

void glint_sheet_destroy(glint_sheet *sheet)
{
    if (sheet != NULL) {
        glint_text_close(sheet->text);
        glint_image_destroy(sheet->image);
        free(sheet);
    }
}

/* What a square of shrink × shrink pixels of the picture becomes, what is beyond its edge left
 * out. */
typedef void shrinking(const glint_image *picture, int shrink, int column, int row, uint8_t to[3]);

static void mean_of(const glint_image *picture, int shrink, int column, int row, uint8_t mean[3])
{
    unsigned sum[3] = {0, 0, 0};
    unsigned count = 0;
    for (int y = row * shrink; y < (row + 1) * shrink && y < picture->height; y++) {
        for (int x = column * shrink; x < (column + 1) * shrink && x < picture->width; x++) {
            const size_t at = (size_t)y * (size_t)picture->width + (size_t)x;
            const uint8_t *rgb = picture->object[at] ? &picture->rgb[3 * at] : background;
            for (int c = 0; c < 3; c++)
                sum[c] += rgb[c];
            count++;
        }
    }
    for (int c = 0; c < 3; c++)
        mean[c] = (uint8_t)((sum[c] + count / 2) / count);
}

/* The mean where none differs. */
static void largest_difference_of(const glint_image *picture, int shrink, int column, int row,
                                  uint8_t to[3])
{
    int largest = 0;
    mean_of(picture, shrink, column, row, to);
    for (int y = row * shrink; y < (row + 1) * shrink && y < picture->height; y++) {
        for (int x = column * shrink; x < (column + 1) * shrink && x < picture->width; x++) {
            const uint8_t *rgb =
                &picture->rgb[3 * ((size_t)y * (size_t)picture->width + (size_t)x)];
            const int rank = glint_image_difference_rank(rgb);
            if (rank > largest) {
                largest = rank;
                memcpy(to, rgb, 3);
            }
        }
    }
}

static void put(glint_sheet *sheet, int row, int column, const glint_image *picture,
                shrinking *become, const char *const lines[2])
{
    const int width = shrunk(sheet->width, sheet->shrink);
    const int height = shrunk(sheet->height, sheet->shrink);
    const int left = MARGIN + column * (sheet->cell_width + MARGIN);
    const int top = MARGIN + row * (LABEL + height + MARGIN);
    if (sheet->text != NULL) {
        const int end = left + sheet->cell_width;
        glint_text_draw(sheet->text, sheet->image, left, top, end, 235, lines[0]);
        glint_text_draw(sheet->text, sheet->image, left, top + LINE, end, 170, lines[1]);
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const size_t to =
                (size_t)(top + LABEL + y) * (size_t)sheet->image->width + (size_t)(left + x);
            become(picture, sheet->shrink, x, y, &sheet->image->rgb[3 * to]);
        }
    }
}

void glint_sheet_put(glint_sheet *sheet, int row, int column, const glint_image *picture,
                     const char *first_line, const char *second_line)
{
    put(sheet, row, column, picture, mean_of, (const char *const[]){first_line, second_line});
}

void glint_sheet_put_difference(glint_sheet *sheet, int row, int column, const glint_image *picture,
                                const char *first_line, const char *second_line)
{
    put(sheet, row, column, picture, largest_difference_of,
        (const char *const[]){first_line, second_line});
}

const glint_image *glint_sheet_image(const glint_sheet *sheet)
{
    return sheet->image;
}

bool glint_sheet_has_words(const glint_sheet *sheet)
{
    return sheet->text != NULL;
}
