/* coulomb-tether: the program's door. */
#include "command/command.h"

int main(int count, char **arguments)
{
    const struct sources sources = embedded_sources();
    return program_run(&sources, count, arguments);
}
