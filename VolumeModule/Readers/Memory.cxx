#include "Readers/Memory.h"

#include "Readers/VolumeFile.h"

#include <vtksys/SystemInformation.hxx>

namespace varimarch
{

double PhysicalMemoryBytes()
{
  static const double bytes =
    1024.0 * double(vtksys::SystemInformation().GetHostMemoryTotal()); // in KiB
  return bytes;
}

std::uint64_t MostMemoryBytes(const ReadOptions& options)
{
  return options.mostMemoryBytes > 0 ? options.mostMemoryBytes
                                     : std::uint64_t(PhysicalMemoryBytes());
}

double FreeMemoryBytes()
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  return 1024.0 * 1024.0 * double(machine.GetAvailablePhysicalMemory()); // in MiB
}

}
