#include "Archive/Association.h"

#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dimse.h>
#include <dcmtk/dcmtls/tlsscu.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

// An image is received only while this much space is free [bytes]: DCMTK cannot stop within one.
constexpr double LeastFreeBytes = 64e6;

// An association that stores images under our names, and listens to the user. Base is DCMTK's class
// without or with TLS.
template <class Base>
class ObservedScu : public Base
{
public:
  explicit ObservedScu(DimseProgress& progress)
    : progress(progress)
  {
  }

private:
  OFCondition handleFINDResponse(const T_ASC_PresentationContextID context, QRResponse* response,
    OFBool& waitForNextResponse) override
  {
    const OFCondition result = Base::handleFINDResponse(context, response, waitForNextResponse);
    ++this->progress.answerCount;
    if (!this->progress.GoesOn() || this->progress.answerCount > Archive::MostFound + 1)
    {
      waitForNextResponse = OFFalse;
    }
    return result;
  }

  OFCondition handleMOVEResponse(const T_ASC_PresentationContextID context,
    RetrieveResponse* response, OFBool& waitForNextResponse) override
  {
    const OFCondition result = Base::handleMOVEResponse(context, response, waitForNextResponse);
    this->progress.remaining = response->m_numberOfRemainingSubops;
    this->progress.GoesOn();
    if (this->progress.IsOver())
    {
      waitForNextResponse = OFFalse;
    }
    return result;
  }

  OFCondition handleCGETResponse(
    const T_ASC_PresentationContextID context, RetrieveResponse* response, OFBool& goesOn) override
  {
    this->progress.remaining = response->m_numberOfRemainingSubops;
    return Base::handleCGETResponse(context, response, goesOn);
  }

  OFCondition handleSTORERequestFile(
    T_ASC_PresentationContextID* context, const OFString&, T_DIMSE_C_StoreRQ* request) override
  {
    const std::string file = this->progress.NextFile();
    this->progress.GoesOn();
    if (this->progress.IsOver())
    {
      return EC_IllegalCall; // ends the association
    }
    return Base::handleSTORERequestFile(context, file.c_str(), request);
  }

  DimseProgress& progress;
};

std::unique_ptr<DcmSCU> MakeScu(
  const ArchiveAddress& address, const DimseEndpoint& endpoint, DimseProgress& progress)
{
  if (!endpoint.isEncrypted)
  {
    return std::make_unique<ObservedScu<DcmSCU>>(progress);
  }
  auto encrypted = std::make_unique<ObservedScu<DcmTLSSCU>>(progress);
  encrypted->addTrustedCertFile(address.certificate.c_str());
  encrypted->setPeerCertVerification(DCV_requireCertificate);
  if (const std::string& own = address.ownCertificate; !own.empty())
  {
    encrypted->enableAuthentication(own.c_str(), own.c_str(), "");
  }
  return encrypted;
}

void SetUp(DcmSCU& scu, const ArchiveAddress& address, const DimseEndpoint& endpoint)
{
  const int patience = std::max(1, int(std::ceil(address.patience)));
  scu.setAETitle(address.ownTitle.c_str());
  scu.setPeerAETitle(endpoint.title.c_str());
  scu.setPeerHostName(endpoint.host.c_str());
  scu.setPeerPort(Uint16(endpoint.port));
  scu.setConnectionTimeout(patience);
  scu.setACSETimeout(Uint32(patience));
  scu.setDIMSETimeout(Uint32(patience));
  scu.setDIMSEBlockingMode(DIMSE_NONBLOCKING);
  scu.setStorageMode(DCMSCU_STORAGE_BIT_PRESERVING);
  scu.setVerbosePCMode(OFFalse);
  dcmSocketReceiveTimeout.set(patience);
  dcmSocketSendTimeout.set(patience);
}

OFList<OFString> ListOf(const std::vector<std::string>& texts)
{
  OFList<OFString> list;
  for (const std::string& text : texts)
  {
    list.push_back(text.c_str());
  }
  return list;
}

}

bool DimseProgress::GoesOn()
{
  const int all = this->imageCount + this->remaining;
  const double part = all > 0 ? double(this->imageCount) / all : -1.0;
  if (!this->isCancelled && !this->report(part))
  {
    this->isCancelled = true;
  }
  return !this->isCancelled;
}

std::string DimseProgress::NextFile()
{
  std::error_code error;
  const auto space = std::filesystem::space(this->folder, error);
  this->isFull = bool(error) || double(space.available) < LeastFreeBytes;
  ++this->imageCount;
  return this->folder + "/image-" + std::to_string(this->imageCount) + ".dcm";
}

Association::Association(
  const ArchiveAddress& address, const std::vector<DimseContext>& contexts, DimseProgress& progress)
  : address(address)
  , progress(progress)
{
  const DimseEndpoint endpoint = DimseEndpointOf(address);
  this->scu = MakeScu(address, endpoint, progress);
  SetUp(*this->scu, address, endpoint);
  for (const DimseContext& context : contexts)
  {
    this->Check(this->scu->addPresentationContext(context.objectClass.c_str(),
      ListOf(context.syntaxes), context.isReceived ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT));
  }
  this->Check(this->scu->initNetwork());
  this->Check(this->scu->negotiateAssociation());
}

// An archive that still sends what is not taken any more gets no orderly end.
Association::~Association()
{
  if (this->scu->isConnected())
  {
    this->scu->closeAssociation(
      this->progress.IsOver() ? DCMSCU_ABORT_ASSOCIATION : DCMSCU_RELEASE_ASSOCIATION);
  }
}

T_ASC_PresentationContextID Association::ContextOf(const std::string& objectClass)
{
  const T_ASC_PresentationContextID context =
    this->scu->findPresentationContextID(objectClass.c_str(), "");
  if (context == 0)
  {
    this->Fail("it does not offer " + std::string(dcmFindNameOfUID(objectClass.c_str(), "this")));
  }
  return context;
}

void Association::Check(const OFCondition& condition) const
{
  if (this->progress.isCancelled)
  {
    throw ArchiveCancelled();
  }
  if (this->progress.isFull)
  {
    this->Fail("there is no free space for its images");
  }
  if (condition.bad())
  {
    this->Fail(FaultText(condition, this->address.patience));
  }
}

void Association::Fail(const std::string& found) const
{
  throw std::runtime_error(
    "The archive \"" + this->address.url + "\" cannot be used: " + found + ".");
}

std::vector<std::string> PlainSyntaxes()
{
  return { UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax };
}

std::vector<std::string> CompressedSyntaxes()
{
  return { UID_JPEG2000LosslessOnlyTransferSyntax, UID_JPEG2000TransferSyntax,
    UID_JPEGProcess14SV1TransferSyntax, UID_JPEGProcess14TransferSyntax,
    UID_JPEGLSLosslessTransferSyntax, UID_JPEGLSLossyTransferSyntax, UID_RLELosslessTransferSyntax,
    UID_JPEGProcess1TransferSyntax, UID_JPEGProcess2_4TransferSyntax };
}

std::vector<std::string> ImageClasses()
{
  return { UID_CTImageStorage, UID_EnhancedCTImageStorage, UID_MRImageStorage,
    UID_EnhancedMRImageStorage, UID_PositronEmissionTomographyImageStorage,
    UID_EnhancedPETImageStorage, UID_NuclearMedicineImageStorage, UID_SecondaryCaptureImageStorage,
    UID_MultiframeGrayscaleByteSecondaryCaptureImageStorage,
    UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage,
    UID_MultiframeTrueColorSecondaryCaptureImageStorage, UID_UltrasoundImageStorage,
    UID_UltrasoundMultiframeImageStorage, UID_EnhancedUSVolumeStorage,
    UID_ComputedRadiographyImageStorage, UID_DigitalXRayImageStorageForPresentation,
    UID_DigitalXRayImageStorageForProcessing, UID_XRayAngiographicImageStorage,
    UID_XRay3DAngiographicImageStorage, UID_XRay3DCraniofacialImageStorage,
    UID_BreastTomosynthesisImageStorage, UID_OphthalmicTomographyImageStorage, UID_RTDoseStorage,
    UID_RTImageStorage, UID_SegmentationStorage, UID_ParametricMapStorage,
    UID_VLPhotographicImageStorage, UID_LegacyConvertedEnhancedCTImageStorage,
    UID_LegacyConvertedEnhancedMRImageStorage, UID_LegacyConvertedEnhancedPETImageStorage };
}

std::string FaultText(const OFCondition& condition, double patience)
{
  if (condition == DIMSE_NODATAAVAILABLE || condition == DUL_READTIMEOUT)
  {
    return "it has been silent for " + std::to_string(int(std::ceil(patience))) + " s";
  }
  if (condition == DIMSE_SENDFAILED)
  {
    return "it has stopped receiving";
  }
  if (condition == DUL_PEERABORTEDASSOCIATION || condition == DUL_NETWORKCLOSED)
  {
    return "it has ended the connection";
  }
  std::string text = condition.text();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.substr(0, text.find_last_not_of(". ") + 1);
}

}
