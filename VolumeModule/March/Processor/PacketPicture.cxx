#include "March/Processor/PacketPicture.h"

#include "Core/Packets/PacketMarch.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

constexpr std::size_t BytesPerPixel = 4 * sizeof(float);

[[noreturn]] void Fail(const Viewport& pixels, const std::string& limit)
{
  throw std::runtime_error("Cannot draw an image of " + std::to_string(pixels.width) + " x " +
    std::to_string(pixels.height) + " pixels: " + limit);
}

}

void PacketPicture::March(vtkOpenGLRenderWindow* window, const std::vector<PacketScene>& scenes,
  const Viewport& newPixels, MarchWork* work)
{
  this->pixels = newPixels;
  const std::size_t countOfPicture = std::size_t(this->pixels.width) * this->pixels.height;
  this->Write(window, scenes.size() * countOfPicture,
    [&](float* rgba)
    {
      for (const PacketScene& scene : scenes)
      {
        MarchPackets(scene, this->pixels, rgba, work);
        rgba += 4 * countOfPicture;
      }
    });
}

void PacketPicture::Take(
  vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& rgba, const Viewport& newPixels)
{
  this->pixels = newPixels;
  this->Write(window, rgba.size(),
    [&](float* texels) { std::copy_n(&rgba.front().x, 4 * rgba.size(), texels); });
}

void PacketPicture::Write(vtkOpenGLRenderWindow* window, std::size_t newCount,
  const std::function<void(float* rgba)>& write)
{
  if (newCount > this->count)
  {
    this->Allocate(window, newCount);
  }
  this->buffer->Bind();
  void* const rgba = glMapBufferRange(GL_TEXTURE_BUFFER, 0, GLsizeiptr(newCount * BytesPerPixel),
    GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (!rgba)
  {
    this->buffer->Release();
    Fail(this->pixels, "memory does not suffice");
  }
  write(static_cast<float*>(rgba));
  glUnmapBuffer(GL_TEXTURE_BUFFER);
  this->buffer->Release();
}

void PacketPicture::Allocate(vtkOpenGLRenderWindow* window, std::size_t newCount)
{
  this->Release(window);
  GLint mostPixels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mostPixels);
  if (newCount > std::size_t(mostPixels))
  {
    Fail(this->pixels,
      "this device's buffer textures have at most " + std::to_string(mostPixels) + " pixels");
  }
  this->buffer->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer);
  this->buffer->Bind();
  glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(newCount * BytesPerPixel), nullptr, GL_STREAM_DRAW);
  this->texture->SetContext(window);
  this->texture->CreateTextureBuffer(unsigned(newCount), 4, VTK_FLOAT, this->buffer);
  this->count = newCount;
}

std::size_t PacketPicture::Bytes() const
{
  return this->count * BytesPerPixel;
}

void PacketPicture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->buffer->ReleaseGraphicsResources();
  this->count = 0;
}

}
