#include "cli/command_line.h"
#include "cli/terminal.h"

int main(int argc, char** argv) {
    calotype::occupyClosedStreams();
    return calotype::runCommandLine(argc, argv);
}
