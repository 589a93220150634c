#include "Archive/ReturnPort.h"

#include <dcmtk/dcmnet/dstorscp.h>
#include <dcmtk/dcmtls/tlslayer.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

namespace varimarch
{

namespace
{

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

}
