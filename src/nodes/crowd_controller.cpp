#include "nodes/programs.h"

int main(int argc, char** argv) { return crowd::runCrowdController(argc, argv); }
