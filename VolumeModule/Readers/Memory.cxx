#include "Readers/Memory.h"

#include <vtksys/SystemInformation.hxx>

namespace varimarch
{

double PhysicalMemoryBytes()
{
  vtksys::SystemInformation machine;
  return 1024.0 * double(machine.GetHostMemoryTotal()); // in KiB
}

double FreeMemoryBytes()
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  return 1024.0 * 1024.0 * double(machine.GetAvailablePhysicalMemory()); // in MiB
}

}
