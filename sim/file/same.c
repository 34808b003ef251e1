/* Compares device and inode numbers. */
#define _POSIX_C_SOURCE 200809L

#include "file/same.h"

#include <sys/stat.h>

bool glint_file_same(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && S_ISREG(of_a.st_mode) &&
           of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
}
