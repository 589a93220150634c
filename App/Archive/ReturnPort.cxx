#include "Archive/ReturnPort.h"

#include <dcmtk/dcmnet/dstorscp.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

namespace varimarch
{

// DCMTK's server, which stores images under our names.
class ReturnPort::Receiver : public DcmStorageSCP
{
public:
  Receiver(const ArchiveAddress& address, DimseProgress& progress)
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
  : receiver(std::make_unique<Receiver>(address, progress))
{
  if (this->receiver->openListenPort().bad())
  {
    throw std::runtime_error("The archive \"" + address.url +
      "\" cannot be used: its images cannot arrive at the port " +
      std::to_string(address.returnPort) + ", which another program uses; choose another.");
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
