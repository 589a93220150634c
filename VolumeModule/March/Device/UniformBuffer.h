#ifndef Varimarch_March_Device_UniformBuffer_h
#define Varimarch_March_Device_UniformBuffer_h

#include <cstddef>

namespace varimarch
{

/// The buffer of a uniform block on the graphics device.
class UniformBuffer
{
public:
  /// Uploads a struct with the memory layout of the block, and binds it.
  template <class Parameters>
  void Upload(unsigned int bindingPoint, const Parameters& parameters)
  {
    this->Upload(bindingPoint, &parameters, sizeof parameters);
  }

  /// Releases the buffer. Its OpenGL context must be current.
  void Release();

private:
  void Upload(unsigned int bindingPoint, const void* bytes, std::size_t count);

  unsigned int handle = 0; ///< OpenGL's name of the buffer; 0 if there is none.
};

}

#endif
