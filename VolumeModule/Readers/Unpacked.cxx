#include "Readers/Unpacked.h"

#include "Readers/Unpacking.h"

namespace varimarch
{

Unpacked::Unpacked(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress)
  : original(path)
{
  const UnpackedContent content =
    Unpack({ path, this->folder.Path().string(), this->folder.FreeBytes() }, progress);
  this->copies = content.path;
  warnings.insert(warnings.end(), content.warnings.begin(), content.warnings.end());
}

std::string Unpacked::WithOriginalPaths(std::string message) const
{
  for (std::size_t place = message.find(this->copies); place != std::string::npos;
       place = message.find(this->copies, place + this->original.size()))
  {
    message.replace(place, this->copies.size(), this->original);
  }
  return message;
}

}
