#ifndef Varimarch_Archive_Association_h
#define Varimarch_Archive_Association_h

#include "Archive/Archive.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/scu.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

/// The images that an association receives, and the user's wish to go on.
struct DimseProgress
{
  const ArchiveProgress& report;
  std::string folder = {};          ///< for images; empty if none are wanted
  std::atomic<int> imageCount{ 0 }; ///< received so far; a thread may count
  int remaining = 0;                ///< number that the archive says are still to come
  std::atomic<bool> isCancelled{ false };
  std::atomic<bool> isFull{ false }; ///< true if there is no space for another image
  std::size_t answerCount = 0;

  /// Tells the progress. @returns whether to go on
  bool GoesOn();

  /// Whether no more images are taken.
  bool IsOver() const { return this->isCancelled || this->isFull; }

  /// The file for the next image. Names that the archive sends are not used.
  std::string NextFile();
};

/// A kind of object and the encodings in which it is to be transferred.
struct DimseContext
{
  std::string objectClass;
  std::vector<std::string> syntaxes;
  bool isReceived = false; ///< true if the archive sends the objects
};

/// An association with an archive (PS3.8), which exists as long as this object.
class Association
{
public:
  /// @throws std::runtime_error with a sentence if the archive cannot be reached, or refuses
  Association(const ArchiveAddress& address, const std::vector<DimseContext>& contexts,
    DimseProgress& progress);
  ~Association();
  Association(const Association&) = delete;
  void operator=(const Association&) = delete;

  DcmSCU* operator->() { return this->scu.get(); }

  /// The accepted context for a class of objects.
  /// @throws std::runtime_error with a sentence if the archive does not know the class
  T_ASC_PresentationContextID ContextOf(const std::string& objectClass);

  /// Checks the result of an operation.
  /// @throws std::runtime_error, ArchiveCancelled
  void Check(const OFCondition& condition) const;

  [[noreturn]] void Fail(const std::string& found) const;

private:
  const ArchiveAddress& address;
  DimseProgress& progress;
  std::unique_ptr<DcmSCU> scu;
};

/// The encodings of uncompressed objects, and of compressed images.
std::vector<std::string> PlainSyntaxes();
std::vector<std::string> CompressedSyntaxes();

/// The classes of images of all usual kinds.
std::vector<std::string> ImageClasses();

/// A fault of DCMTK in words.
std::string FaultText(const OFCondition& condition, double patience);

}

#endif
