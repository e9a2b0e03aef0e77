// Writes docs/precision-hard-cases.md: hard_cases_report FILE.
#include "tests/hard_cases/hard_cases.h"

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: hard_cases_report FILE.md\n");
        return 2;
    }
    std::ofstream file(argv[1]);
    file << hard_cases::page(hard_cases::measure());
    return file.flush() ? 0 : 1;
}
