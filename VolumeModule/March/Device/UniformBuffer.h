#ifndef Varimarch_March_Device_UniformBuffer_h
#define Varimarch_March_Device_UniformBuffer_h

#include <cstddef>

namespace varimarch
{

/// The numbers of a uniform block on the graphics device.
class UniformBuffer
{
public:
  /// Uploads a struct whose members lie as those of the block, and binds it.
  template <class Parameters>
  void Upload(unsigned int bindingPoint, const Parameters& parameters)
  {
    this->Upload(bindingPoint, &parameters, sizeof parameters);
  }

  /// In the context that has it.
  void Release();

private:
  void Upload(unsigned int bindingPoint, const void* bytes, std::size_t count);

  unsigned int handle = 0; ///< 0: there is none
};

}

#endif
