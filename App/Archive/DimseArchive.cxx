#include "Archive/Archive.h"

#include "Archive/Association.h"

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/diutil.h>
#include <dcmtk/dcmnet/dstorscp.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <dcmtk/oflog/oflog.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

class DcmTransportLayer;

namespace varimarch
{

namespace
{

/// A port at which images arrive that C-MOVE has asked for, as long as this object lives. It takes
/// images only from a program with the title of the archive, for our own title. If the archive is
/// reached by TLS, it must use TLS here too, with a certificate that we trust for it.
class ReturnPort
{
public:
  /// @param progress  counts the images; must outlive this object
  /// @throws std::runtime_error with a sentence if the port is in use, or our certificate is unfit
  ReturnPort(const ArchiveAddress& address, DimseProgress& progress);
  ~ReturnPort();
  ReturnPort(const ReturnPort&) = delete;
  void operator=(const ReturnPort&) = delete;

private:
  class Receiver;

  std::unique_ptr<DcmTransportLayer> encryption; ///< null without TLS; must outlive the receiver
  std::unique_ptr<Receiver> receiver;
  std::thread thread;
};

[[noreturn]] void Fail(const ArchiveAddress& address, const std::string& reason)
{
  throw std::runtime_error("The archive \"" + address.url + "\" cannot be used: " + reason + ".");
}

// TLS as the archive is reached by; null if it is reached without.
std::unique_ptr<DcmTransportLayer> EncryptionFor(const ArchiveAddress& address)
{
  if (!DimseEndpointOf(address).isEncrypted)
  {
    return nullptr;
  }
  auto layer = std::make_unique<DcmTLSTransportLayer>(NET_ACCEPTOR, nullptr, OFTrue);
  const char* const own = address.ownCertificate.c_str();
  layer->setPrivateKeyPasswd(""); // DCMTK would ask for one
  const bool isReady = layer->setPrivateKeyFile(own, DCF_Filetype_PEM).good() &&
    layer->setCertificateFile(own, DCF_Filetype_PEM).good() &&
    layer->checkPrivateKeyMatchesCertificate() &&
    layer->addTrustedCertificateFile(address.certificate.c_str(), DCF_Filetype_PEM).good() &&
    layer->setTLSProfile(TSP_Profile_BCP195).good() && layer->activateCipherSuites().good();
  if (!isReady)
  {
    Fail(address,
      "the certificate and the private key in \"" + address.ownCertificate +
        "\" do not fit each other or TLS");
  }
  layer->setCertificateVerification(DCV_requireCertificate);
  return layer;
}

// DCMTK's server, which stores images under our names.
class ReturnPort::Receiver : public DcmStorageSCP
{
public:
  Receiver(const ArchiveAddress& address, DcmTransportLayer* encryption, DimseProgress& progress)
    : archiveTitle(DimseEndpointOf(address).title)
    , ownTitle(address.ownTitle)
    , progress(progress)
  {
    const auto patience = Uint32(std::ceil(address.patience));
    this->setPort(Uint16(address.returnPort));
    this->setAETitle(address.ownTitle.c_str());
    this->setOutputDirectory(progress.folder.c_str());
    this->setDatasetStorageMode(DGM_StoreBitPreserving);
    this->setConnectionBlockingMode(DUL_NOBLOCK);
    this->setConnectionTimeout(1);
    this->setDIMSEBlockingMode(DIMSE_NONBLOCKING);
    this->setDIMSETimeout(patience);
    this->setACSETimeout(patience);
    this->setHostLookupEnabled(OFFalse);
    this->getConfig().setTransportLayer(encryption);
    OFList<OFString> syntaxes;
    for (const auto& some : { PlainSyntaxes(), CompressedSyntaxes() })
    {
      for (const std::string& syntax : some)
      {
        syntaxes.push_back(syntax.c_str());
      }
    }
    for (const std::string& objectClass : ImageClasses())
    {
      this->addPresentationContext(objectClass.c_str(), syntaxes);
    }
  }

  std::atomic<bool> stop{ false };

private:
  OFBool stopAfterCurrentAssociation() override { return this->stop; }
  OFBool stopAfterConnectionTimeout() override { return this->stop; }

  OFBool checkCalledAETitleAccepted(const OFString& title) override
  {
    return this->ownTitle == title.c_str();
  }
  OFBool checkCallingAETitleAccepted(const OFString& title) override
  {
    return this->archiveTitle == title.c_str();
  }

  OFCondition generateSTORERequestFilename(const T_DIMSE_C_StoreRQ&, OFString& filename) override
  {
    filename = this->progress.NextFile().c_str();
    return this->progress.IsOver() ? EC_IllegalCall : EC_Normal; // a fault ends the association
  }

  std::string archiveTitle;
  std::string ownTitle;
  DimseProgress& progress;
};

ReturnPort::ReturnPort(const ArchiveAddress& address, DimseProgress& progress)
  : encryption(EncryptionFor(address))
  , receiver(std::make_unique<Receiver>(address, this->encryption.get(), progress))
{
  if (this->receiver->openListenPort().bad())
  {
    Fail(address,
      "its images cannot arrive at the port " + std::to_string(address.returnPort) +
        ", which another program uses; choose another");
  }
  this->thread = std::thread([this] { this->receiver->acceptAssociations(); });
}

// The thread looks every second whether to stop.
ReturnPort::~ReturnPort()
{
  this->receiver->stop = true;
  this->thread.join();
}

constexpr const char* FindClass = UID_FINDStudyRootQueryRetrieveInformationModel;
constexpr const char* GetClass = UID_GETStudyRootQueryRetrieveInformationModel;
constexpr const char* MoveClass = UID_MOVEStudyRootQueryRetrieveInformationModel;

using Words = std::map<DcmTagKey, std::string>;

// A search, or a list of what to fetch.
DcmDataset DatasetOf(const char* level, const Words& words)
{
  DcmDataset dataset;
  dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
  dataset.putAndInsertString(DCM_QueryRetrieveLevel, level);
  for (const auto& [tag, word] : words)
  {
    dataset.putAndInsertString(tag, word.c_str());
  }
  return dataset;
}

std::string TextOf(DcmDataset& dataset, const DcmTagKey& tag)
{
  OFString text;
  dataset.findAndGetOFStringArray(tag, text);
  return text.c_str();
}

// True for texts that mean the same in all sets of characters: no escape sequence chooses one.
bool IsPlain(const std::string& text)
{
  return std::all_of(
    text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; });
}

// An entry that a search has found, in UTF-8.
class FoundEntry
{
public:
  explicit FoundEntry(DcmDataset& dataset)
    : dataset(dataset)
    , isConverted(dataset.convertToUTF8().good())
  {
  }

  // A text. It is empty if it would be read as another one.
  std::string Text(const DcmTagKey& tag)
  {
    std::string text = TextOf(this->dataset, tag);
    if (this->isConverted || IsPlain(text))
    {
      return text;
    }
    this->hasUnreadable = true;
    return {};
  }

  // True if one of the texts so far could not be read.
  bool HasUnreadable() const { return this->hasUnreadable; }

private:
  DcmDataset& dataset;
  bool isConverted;
  bool hasUnreadable = false;
};

// The study, or the series of it, that is to be fetched.
DcmDataset Wanted(const std::string& study, const std::string& series)
{
  CheckUid(study);
  Words words = { { DCM_StudyInstanceUID, study } };
  if (!series.empty())
  {
    CheckUid(series);
    words[DCM_SeriesInstanceUID] = series;
  }
  return DatasetOf(series.empty() ? "STUDY" : "SERIES", words);
}

// Checks the last answer to a wish for images.
void CheckTransfer(const Association& association, const RetrieveResponse& last)
{
  if (last.m_numberOfFailedSubops > 0)
  {
    association.Fail(
      "it has failed to send images: " + std::to_string(last.m_numberOfFailedSubops));
  }
  if (DICOM_FAILURE_STATUS(last.m_status))
  {
    association.Fail(std::string("it refuses to send: ") + DU_cmoveStatusString(last.m_status));
  }
}

// Answers of an archive, which DCMTK leaves to its caller.
template <class Response>
struct Responses
{
  Responses() = default;
  ~Responses()
  {
    for (Response* const response : this->list)
    {
      delete response;
    }
  }
  Responses(const Responses&) = delete;
  void operator=(const Responses&) = delete;

  OFList<Response*> list;
};

// The answers to a search.
class Answers
{
public:
  Answers(const ArchiveAddress& address, const char* level, const Words& words,
    const ArchiveProgress& report)
  {
    DimseProgress progress{ report };
    Association association(address, { { FindClass, PlainSyntaxes() } }, progress);
    DcmDataset query = DatasetOf(level, words);
    const OFCondition result =
      association->sendFINDRequest(association.ContextOf(FindClass), &query, &this->responses.list);
    if (progress.answerCount > Archive::MostFound + 1)
    {
      progress.isCancelled = true; // ends the association at once
      association.Fail(
        "more than " + std::to_string(Archive::MostFound) + " entries match; search for less");
    }
    association.Check(result);
    const Uint16 status = this->responses.list.empty() ? 0 : this->responses.list.back()->m_status;
    if (!this->responses.list.empty() && DICOM_FAILURE_STATUS(status))
    {
      association.Fail(std::string("it refuses to search: ") + DU_cfindStatusString(status));
    }
  }

  // Calls a function with each entry that was found.
  template <class Function>
  void ForEach(const Function& take)
  {
    for (QRResponse* const response : this->responses.list)
    {
      if (response->m_dataset)
      {
        take(FoundEntry(*response->m_dataset));
      }
    }
  }

private:
  Responses<QRResponse> responses;
};

// Texts with backslashes, as DICOM separates values, as people write them.
std::string Listed(std::string text)
{
  for (std::size_t place = 0; (place = text.find('\\', place)) != std::string::npos; place += 2)
  {
    text.replace(place, 1, ", ");
  }
  return text;
}

// Contexts in which an archive sends images. It takes the compressed one for those that it has
// compressed.
void AddImageContexts(std::vector<DimseContext>& contexts)
{
  for (const std::string& objectClass : ImageClasses())
  {
    contexts.push_back({ objectClass, PlainSyntaxes(), true });
    contexts.push_back({ objectClass, CompressedSyntaxes(), true });
  }
}

// The class and the encoding of a file, of which only the head is read.
DimseContext ContextOfFile(const std::string& path)
{
  DcmFileFormat file;
  OFString objectClass;
  OFString syntax;
  const bool isRead =
    file.loadFile(path.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_metaOnly)
      .good() &&
    file.getMetaInfo()->findAndGetOFString(DCM_MediaStorageSOPClassUID, objectClass).good() &&
    file.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax).good();
  if (!isRead)
  {
    throw std::runtime_error(
      "Cannot send \"" + path + "\": expected a DICOM file, found another or none.");
  }
  return { objectClass.c_str(), { syntax.c_str() } };
}

/// An archive that speaks DICOM's own protocol (PS3.7), by DCMTK: C-ECHO, C-FIND in the model
/// "Study Root", C-GET or C-MOVE, and C-STORE. Images are written as they come, and parsed by
/// nobody.
class DimseArchive : public Archive
{
public:
  explicit DimseArchive(const ArchiveAddress& address);

  void Check(const ArchiveProgress& progress) override;
  std::vector<ArchiveStudy> FindStudies(
    const ArchiveQuery& query, const ArchiveProgress& progress) override;
  std::vector<ArchiveSeries> FindSeries(
    const std::string& study, const ArchiveProgress& progress) override;
  int Fetch(const std::string& study, const std::string& series, const std::string& folder,
    const ArchiveProgress& progress) override;
  void Send(const std::vector<std::string>& files, const ArchiveProgress& progress) override;

private:
  ArchiveAddress address;
};

DimseArchive::DimseArchive(const ArchiveAddress& address)
  : address(address)
{
  // DCMTK would print names of patients.
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
}

void DimseArchive::Check(const ArchiveProgress& report)
{
  DimseProgress progress{ report };
  Association association(
    this->address, { { UID_VerificationSOPClass, PlainSyntaxes() } }, progress);
  association.Check(association->sendECHORequest(association.ContextOf(UID_VerificationSOPClass)));
}

std::vector<ArchiveStudy> DimseArchive::FindStudies(
  const ArchiveQuery& query, const ArchiveProgress& progress)
{
  Answers answers(this->address, "STUDY",
    { { DCM_PatientName, NamePattern(query) }, { DCM_PatientID, query.patientId },
      { DCM_StudyDate, query.dates }, { DCM_ModalitiesInStudy, query.modality },
      { DCM_StudyInstanceUID, "" }, { DCM_StudyDescription, "" } },
    progress);
  std::vector<ArchiveStudy> studies;
  answers.ForEach(
    [&](FoundEntry study)
    {
      studies.push_back({ study.Text(DCM_StudyInstanceUID), study.Text(DCM_PatientName),
        study.Text(DCM_PatientID), study.Text(DCM_StudyDate), study.Text(DCM_StudyDescription),
        Listed(study.Text(DCM_ModalitiesInStudy)) });
      studies.back().hasUnreadableTexts = study.HasUnreadable();
    });
  return studies;
}

std::vector<ArchiveSeries> DimseArchive::FindSeries(
  const std::string& study, const ArchiveProgress& progress)
{
  CheckUid(study);
  Answers answers(this->address, "SERIES",
    { { DCM_StudyInstanceUID, study }, { DCM_SeriesInstanceUID, "" }, { DCM_SeriesNumber, "" },
      { DCM_SeriesDescription, "" }, { DCM_Modality, "" },
      { DCM_NumberOfSeriesRelatedInstances, "" } },
    progress);
  std::vector<ArchiveSeries> all;
  answers.ForEach(
    [&](FoundEntry series)
    {
      all.push_back({ series.Text(DCM_SeriesInstanceUID), series.Text(DCM_SeriesNumber),
        series.Text(DCM_SeriesDescription), series.Text(DCM_Modality),
        series.Text(DCM_NumberOfSeriesRelatedInstances) });
      all.back().hasUnreadableTexts = series.HasUnreadable();
    });
  return all;
}

int DimseArchive::Fetch(const std::string& study, const std::string& series,
  const std::string& folder, const ArchiveProgress& report)
{
  const bool isMove = this->address.returnPort != 0;
  const char* const objectClass = isMove ? MoveClass : GetClass;
  std::vector<DimseContext> contexts = { { objectClass, PlainSyntaxes() } };
  if (!isMove)
  {
    AddImageContexts(contexts);
  }
  DcmDataset wanted = Wanted(study, series);
  DimseProgress progress{ report, folder };
  std::optional<ReturnPort> arrival;
  if (isMove)
  {
    arrival.emplace(this->address, progress);
  }
  Association association(this->address, contexts, progress);
  const T_ASC_PresentationContextID context = association.ContextOf(objectClass);
  Responses<RetrieveResponse> responses;
  const OFCondition result = isMove
    ? association->sendMOVERequest(
        context, this->address.ownTitle.c_str(), &wanted, &responses.list)
    : association->sendCGETRequest(context, &wanted, &responses.list);
  arrival.reset(); // all images have arrived
  association.Check(result);
  if (!responses.list.empty())
  {
    CheckTransfer(association, *responses.list.back());
  }
  if (progress.imageCount == 0)
  {
    association.Fail("it sends no image");
  }
  return progress.imageCount;
}

void DimseArchive::Send(const std::vector<std::string>& files, const ArchiveProgress& report)
{
  std::vector<DimseContext> contexts;
  std::set<std::pair<std::string, std::string>> known;
  for (const std::string& file : files)
  {
    const DimseContext context = ContextOfFile(file);
    if (known.insert({ context.objectClass, context.syntaxes.front() }).second)
    {
      contexts.push_back(context);
    }
  }
  DimseProgress progress{ report };
  progress.remaining = int(files.size());
  Association association(this->address, contexts, progress);
  for (const std::string& file : files)
  {
    Uint16 status = 0;
    progress.GoesOn();
    association.Check({});
    const OFCondition result = association->sendSTORERequest(0, file.c_str(), nullptr, status);
    if (result.good() && DICOM_FAILURE_STATUS(status))
    {
      association.Fail("it has not stored \"" + file + "\": " + DU_cstoreStatusString(status));
    }
    association.Check(result);
    ++progress.imageCount;
    --progress.remaining;
  }
}

}

std::unique_ptr<Archive> DimseArchiveAt(const ArchiveAddress& address)
{
  return std::make_unique<DimseArchive>(address);
}

}
