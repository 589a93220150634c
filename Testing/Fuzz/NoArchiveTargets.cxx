// The place of ArchiveTargets.cxx without the library of archives.
#include "Fuzz/FuzzTarget.h"

namespace varimarch
{

std::vector<FuzzTarget> ArchiveTargets()
{
  return {};
}

}
