#ifndef Varimarch_Readers_Packed_PrivateFolder_h
#define Varimarch_Readers_Packed_PrivateFolder_h

#include "VarimarchVolumeModule.h"

#include <filesystem>

namespace varimarch
{

/// A folder that no other user can read, for copies of a patient's data. It is deleted with this
/// object; what a killed program has left is deleted when the next such folder is made. It lies in
/// memory where the system allows, so that the copies reach no disk.
class VARIMARCHVOLUME_EXPORT PrivateFolder
{
public:
  /// @throws std::runtime_error if it cannot be made
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  void operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& Path() const { return this->path; }

  /// Space for files in this folder, at most the free memory [bytes].
  double FreeBytes() const;

private:
  std::filesystem::path path;
  int lock = -1; ///< descriptor of the folder, locked as long as this process lives
};

}

#endif
