#include <stdio.h>

#include "PREFIX.h"

/* Reads lines of a place and a speed, and prints all columns there: the value and its derivatives. */
int main(void)
{
    double at, speed, found[UPPER_COLUMNS][UPPER_ORDERS];
    while (scanf("%lf %lf", &at, &speed) == 2) {
        if (PREFIX_at(at, speed, found)) {
            printf("beyond\n");
            continue;
        }
        for (int column = 0; column < UPPER_COLUMNS; column++) {
            for (int order = 0; order < UPPER_ORDERS; order++) {
                printf("%.17g ", found[column][order]);
            }
        }
        printf("\n");
    }
    return 0;
}
