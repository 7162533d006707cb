#ifndef CATCH2_3
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif

// Large pages, as in the program.
extern "C" {
__attribute__((visibility("default"))) const char* malloc_conf = "thp:always";
}
