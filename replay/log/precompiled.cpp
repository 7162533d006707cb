// This file is compiled once; every folder that reads run logs uses its precompiled headers.
