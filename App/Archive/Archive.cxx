#include "Archive/Archive.h"

#include "Archive/DimseArchive.h"
#include "Archive/WebArchive.h"

namespace varimarch
{

std::string NamePattern(const ArchiveQuery& query)
{
  const std::string& name = query.patientName;
  return name.empty() || name.find_first_of("*?") != std::string::npos ? name : name + '*';
}

std::unique_ptr<Archive> ArchiveAt(const ArchiveAddress& address, const std::string& password)
{
  CheckAddress(address);
  if (IsDimse(address))
  {
    return std::make_unique<DimseArchive>(address);
  }
  return std::make_unique<WebArchive>(address, password);
}

}
