#include "March/Device/UniformBuffer.h"
#include "VtkVersions.h"

namespace varimarch
{

void UniformBuffer::Upload(unsigned int bindingPoint, const void* bytes, std::size_t count)
{
  if (this->handle == 0)
  {
    glGenBuffers(1, &this->handle);
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, bindingPoint, this->handle);
  glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(count), bytes, GL_STREAM_DRAW);
}

void UniformBuffer::Release()
{
  if (this->handle != 0)
  {
    glDeleteBuffers(1, &this->handle);
    this->handle = 0;
  }
}

}
