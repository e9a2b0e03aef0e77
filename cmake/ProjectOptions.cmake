# What every target of ours is compiled with.

option(PAIRLIGHT_WARNINGS_AS_ERRORS "Stop at the first warning" OFF)
option(PAIRLIGHT_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)   # target all_verify_interface_header_sets: every header compiles alone

add_library(project_options INTERFACE)
target_compile_options(project_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -Wno-missing-field-initializers   # a designated initialiser leaves the rest at its defaults on purpose
    # g++ 12 at -O3 takes std::string's own operator+ and moved-from optionals for overflows (GCC bugs
    # 105651, 105562); what these five would find is the sanitizers' to find.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds;-Wno-maybe-uninitialized>
    -ffp-contract=off   # the same sums on every processor, whether it can fuse multiply and add or not
    $<$<BOOL:${PAIRLIGHT_WARNINGS_AS_ERRORS}>:-Werror>)
if(PAIRLIGHT_SANITIZE)
    target_compile_options(project_options INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(project_options INTERFACE -fsanitize=address,undefined)
endif()
target_compile_definitions(project_options INTERFACE
    PAIRLIGHT_PROGRAM_VERSION="pairlight ${PROJECT_VERSION}")

# precompile_common_headers(TARGET [<header>...]): what nearly every file includes, compiled once for all
# of them: half the time of a file that is short.  The dev preset does without, so that a file that
# includes too little is found.
function(precompile_common_headers target)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory>
        <optional> <span> <string> <variant> <vector> <fmt/format.h> <tl/expected.hpp> ${ARGN})
endfunction()
