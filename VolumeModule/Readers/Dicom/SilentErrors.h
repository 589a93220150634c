#ifndef Varimarch_Readers_Dicom_SilentErrors_h
#define Varimarch_Readers_Dicom_SilentErrors_h

#include <mutex>

namespace varimarch
{

/// Scope guard that discards what the process prints to its standard error output. GDCM and the C
/// libraries for JPEG print there what the reader reports as a warning or an error of its own.
/// Messages of other threads are lost too, so it should live only while a file is decoded. A second
/// guard in another thread waits for the first.
class SilentErrors
{
public:
  SilentErrors();
  ~SilentErrors();
  SilentErrors(const SilentErrors&) = delete;
  void operator=(const SilentErrors&) = delete;

private:
  std::unique_lock<std::mutex> lock;
  int printed; ///< descriptor of the original output, or -1 if it could not be replaced
};

}

#endif
