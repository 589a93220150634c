#ifndef Varimarch_Archive_Archive_h
#define Varimarch_Archive_Archive_h

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

/// Everything that is needed to reach an archive, except a password.
struct ArchiveAddress
{
  /// "dicom://TITLE@host:port" for DIMSE, "dicoms:" for DIMSE in TLS, where TITLE is the archive's
  /// application entity title; "https://host/dicom-web" or "http:" for DICOMweb.
  std::string url;
  std::string ownTitle = "VARIMARCH"; ///< our application entity title, for DIMSE
  /// Certificate of the archive or of its authority (PEM). DIMSE in TLS needs one; DICOMweb trusts
  /// the system's authorities too.
  std::string certificate;
  /// A file with our own certificate and its private key without a password (PEM), for DIMSE in
  /// TLS: archives may ask for it, and C-MOVE needs it. Empty without one.
  std::string ownCertificate;
  /// Port at which we receive what C-MOVE fetches; 0 to fetch by C-GET.
  int returnPort = 0;
  std::string user; ///< for DICOMweb; empty without a password
  /// The longest time without an answer [s], > 0.
  double patience = 30.0;
};

/// The parts of a URL of DIMSE.
struct DimseEndpoint
{
  std::string title; ///< 1 to 16 characters
  std::string host;
  int port;
  bool isEncrypted;
};

bool IsDimse(const ArchiveAddress& address);

/// @throws std::invalid_argument with one sentence if the URL cannot be understood
DimseEndpoint DimseEndpointOf(const ArchiveAddress& address);

/// Checks an address, and the files of its certificates, without using the network.
/// @throws std::invalid_argument with one sentence that says what is wrong
void CheckAddress(const ArchiveAddress& address);

/// Checks that a text is a unique identifier of DICOM: digits and dots, at most 64 (PS3.5 9.1).
/// Any other from a forged answer may be a path, a wild card, a list or empty, which asks for all.
/// @throws std::runtime_error with one sentence if it is none
void CheckUid(const std::string& text);

/// Words to search studies for. Empty ones match all.
struct ArchiveQuery
{
  std::string patientName; ///< "DOE" finds all names that begin so; '*' and '?' are wild cards
  std::string patientId;
  std::string dates; ///< "20261126", or a range "20260101-20261231", open on either side
  std::string modality;
};

/// The name as a pattern. People type its beginning, but archives compare all of it.
std::string NamePattern(const ArchiveQuery& query);

/// A study in an archive. It identifies the patient. Texts are in UTF-8; any may be empty.
struct ArchiveStudy
{
  std::string uid;
  std::string patientName; ///< as stored, "DOE^JANE"
  std::string patientId;
  std::string date; ///< as stored, "20261126"
  std::string description;
  std::string modalities; ///< "CT, SEG"
  /// True if texts are empty because they are in a set of characters that is unknown or another one
  /// than the archive says: they would be read as other names.
  bool hasUnreadableTexts = false;
};

struct ArchiveSeries
{
  std::string uid;
  std::string number;
  std::string description;
  std::string modality;
  std::string imageCount;          ///< empty if the archive does not tell
  bool hasUnreadableTexts = false; ///< as in a study
};

/// The number of studies or series with texts that cannot be read.
template <class Found>
auto UnreadableCount(const std::vector<Found>& found)
{
  return std::count_if(
    found.begin(), found.end(), [](const Found& one) { return one.hasUnreadableTexts; });
}

/// Receives the fraction of the work done, [0, 1], or a negative number if that is unknown; returns
/// false to cancel.
using ArchiveProgress = std::function<bool(double)>;

/// Thrown if the user has cancelled.
struct ArchiveCancelled
{
};

/// A connection to an archive of images (PACS). Each function opens a connection of its own. Each
/// throws std::runtime_error with one sentence that names the archive and what failed: an archive
/// that is silent for as long as its address allows has failed too.
class Archive
{
public:
  virtual ~Archive() = default;

  /// The most studies or series that a search may find.
  static constexpr std::size_t MostFound = 1000;

  /// Asks the archive to answer.
  virtual void Check(const ArchiveProgress& progress) = 0;

  /// @throws std::runtime_error also if more than MostFound match
  virtual std::vector<ArchiveStudy> FindStudies(
    const ArchiveQuery& query, const ArchiveProgress& progress) = 0;
  virtual std::vector<ArchiveSeries> FindSeries(
    const std::string& study, const ArchiveProgress& progress) = 0;

  /// Fetches the images of a study, or of one of its series, into files "image-1.dcm" and so on of
  /// a folder.
  /// @param series  empty for all
  /// @returns the number of images, at least 1
  virtual int Fetch(const std::string& study, const std::string& series, const std::string& folder,
    const ArchiveProgress& progress) = 0;

  /// Sends DICOM files.
  virtual void Send(const std::vector<std::string>& files, const ArchiveProgress& progress) = 0;
};

/// The archive at an address. Nothing is sent yet.
/// @param password  for the user of the address; it is sent only through TLS or to this computer
/// @throws std::runtime_error if the address asks for something that there is no way to do
std::unique_ptr<Archive> ArchiveAt(const ArchiveAddress& address, const std::string& password);

/// The two kinds of archives, for ArchiveAt: DICOM's own protocol (PS3.7), and DICOMweb (PS3.18).
std::unique_ptr<Archive> DimseArchiveAt(const ArchiveAddress& address);
std::unique_ptr<Archive> WebArchiveAt(const ArchiveAddress& address, const std::string& password);

}

#endif
