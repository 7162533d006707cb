// Compiled once, so that its precompiled headers serve every test program.
