/* Prints the digests of the C model, as compiled for some machine. */
#include <stdio.h>

#include "digest.h"

int main(void)
{
    portability_print(stdout);
    return fflush(stdout) == 0 ? 0 : 2;
}
