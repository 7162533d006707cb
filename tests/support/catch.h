// Catch2 2 and 3 under one name.
#pragma once
#ifdef CATCH2_3
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
