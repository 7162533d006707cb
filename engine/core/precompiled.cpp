// This file is compiled once; every library uses its precompiled headers.
