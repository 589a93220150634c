#ifndef Varimarch_CommandLine_ArchiveArguments_h
#define Varimarch_CommandLine_ArchiveArguments_h

#include "Archive/Archive.h"

#include <string>
#include <vector>

namespace varimarch
{

struct ArchiveFindArguments
{
  ArchiveAddress address;
  ArchiveQuery query;
  std::string study; ///< UID of the study whose series are listed; empty to search studies
};

struct ArchiveGetArguments
{
  ArchiveAddress address;
  std::string study;
  std::string series; ///< empty for all of the study
  std::string folder;
};

struct ArchiveSendArguments
{
  ArchiveAddress address;
  std::vector<std::string> files;
};

/// Asks an archive to answer.
void RunArchiveCheck(const ArchiveAddress& address);

/// Prints the studies of an archive that match, or the series of a study.
void RunArchiveFind(const ArchiveFindArguments& arguments);

/// Fetches images into a new folder.
void RunArchiveGet(const ArchiveGetArguments& arguments);

/// Sends files to an archive.
void RunArchiveSend(const ArchiveSendArguments& arguments);

}

#endif
