#include "nodes/programs.h"

int main(int argc, char** argv) { return crowd::runRobotController(argc, argv); }
