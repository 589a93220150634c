#include "Readers/Memory.h"

#include <vtksys/SystemInformation.hxx>

namespace varimarch
{

double PhysicalMemoryBytes()
{
  static const double bytes =
    1024.0 * double(vtksys::SystemInformation().GetHostMemoryTotal()); // in KiB
  return bytes;
}

double FreeMemoryBytes()
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  return 1024.0 * 1024.0 * double(machine.GetAvailablePhysicalMemory()); // in MiB
}

}
