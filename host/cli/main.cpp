#include "cli/command_line.h"

int main(int argc, char** argv) { return calotype::runCommandLine(argc, argv); }
