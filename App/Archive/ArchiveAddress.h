#ifndef Varimarch_Archive_ArchiveAddress_h
#define Varimarch_Archive_ArchiveAddress_h

#include <cstddef>
#include <string>

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

}

#endif
