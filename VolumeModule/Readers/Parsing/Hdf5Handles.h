#ifndef Varimarch_Readers_Parsing_Hdf5Handles_h
#define Varimarch_Readers_Parsing_Hdf5Handles_h

#include <hdf5.h>

namespace varimarch
{

/// An identifier of HDF5, which is closed at the end.
class Hdf5Handle
{
public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t))
    : id(id)
    , close(close)
  {
  }
  ~Hdf5Handle()
  {
    if (this->id >= 0)
    {
      this->close(this->id);
    }
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  void operator=(const Hdf5Handle&) = delete;

  operator hid_t() const { return this->id; }

private:
  hid_t id;
  herr_t (*close)(hid_t);
};

/// Stops HDF5 from printing errors, until the end of a function.
class SilentHdf5
{
public:
  SilentHdf5()
  {
    H5Eget_auto(H5E_DEFAULT, &this->print, &this->data);
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
  }
  ~SilentHdf5() { H5Eset_auto(H5E_DEFAULT, this->print, this->data); }
  SilentHdf5(const SilentHdf5&) = delete;
  void operator=(const SilentHdf5&) = delete;

private:
  H5E_auto2_t print = nullptr;
  void* data = nullptr;
};

}

#endif
