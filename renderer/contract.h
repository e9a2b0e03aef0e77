// EXPECTS: what a caller owes a function.  Alive in every build; a breach is a bug, so it ends the
// program.
#pragma once

#include <cstdio>
#include <cstdlib>

#define EXPECTS(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            std::fprintf(stderr, "%s:%d: expected %s\n", __FILE__, __LINE__, #condition);          \
            std::abort();                                                                          \
        }                                                                                          \
    } while (false)
