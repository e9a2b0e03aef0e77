// Writes docs/precision.md: precision_report FILE.
#include "tests/analysis/precision.h"

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: precision_report FILE.md\n");
        return 2;
    }
    std::ofstream file(argv[1]);
    file << precision::page(precision::measure());
    return file.flush() ? 0 : 1;
}
