// The executable that tests/precompiled.h is compiled for.
