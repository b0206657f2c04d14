/* Takes turns with a kernel: solves the rows of the file `in`, and writes what it finds to the file named as the first argument.
   For each line of its input it then solves all rows ten times, and writes the nanoseconds of the shortest of these passes. */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* ARGUMENTS, RESULTS and ROWS are given to the compiler. */
int kernel(const double *in, double *out);

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

int main(int count, char **words)
{
    static double in[ROWS][ARGUMENTS];
    static double out[ROWS][RESULTS];
    FILE *file = fopen("in", "rb");
    if (count != 2 || file == NULL || fread(in, sizeof in, 1, file) != 1) {
        return 1;
    }
    fclose(file);
    for (int row = 0; row < ROWS; row++) {
        if (kernel(in[row], out[row]) != 0) {
            return 2;
        }
    }
    file = fopen(words[1], "wb");
    if (file == NULL || fwrite(out, sizeof out, 1, file) != 1 || fclose(file) != 0) {
        return 3;
    }
    puts("ready");
    fflush(stdout);
    while (getchar() != EOF) {
        double shortest = HUGE_VAL;
        for (int pass = 0; pass < 10; pass++) {
            const double start = now();
            for (int row = 0; row < ROWS; row++) {
                (void)kernel(in[row], out[0]);
                /* What is found counts as read. */
                __asm__ volatile("" ::"r"(out) : "memory");
            }
            const double time = now() - start;
            shortest = time < shortest ? time : shortest;
        }
        printf("%.0f\n", shortest);
        fflush(stdout);
    }
    return 0;
}
