#include "AddArchiveCommand.h"

namespace varimarch
{

void AddArchiveCommand(CLI::App&) {}

}
