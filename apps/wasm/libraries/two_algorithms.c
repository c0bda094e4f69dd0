// See two_algorithms.h: NLOPT_INVALID_ARGS, and DIRECT_INVALID_ARGS.
int plico_no_algorithm(void) { return -2; }
int plico_no_direct(void) { return -101; }
