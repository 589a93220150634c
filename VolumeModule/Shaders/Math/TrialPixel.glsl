// The pixel of an image that a ray of a trial image belongs to. Blocks of 4 x 2 rays, one packet of
// the processor, each have a part of the image. Their pixels are equally far apart, but how far and
// from where on is random for each block. So the rays have no grid that could meet one in the data,
// and they are always the same. The random numbers are those of "pcg2d" in M. Jarzynski, M. Olano,
// "Hash functions for GPU rendering", Journal of Computer Graphics Techniques 9 (3), 2020.

uvec2 HashOf(ivec2 numbers)
{
  uvec2 hash = uvec2(numbers) * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round)
  {
    hash.x += hash.y * 1664525u;
    hash.y += hash.x * 1664525u;
    hash = hash ^ (hash >> 16u);
  }
  return hash;
}

// `rays` columns and rows of rays: multiples of 4 and 2, or as many as there are pixels.
ivec2 TrialPixel(ivec2 ray, ivec2 rays, ivec2 pixels)
{
  ivec2 block = ivec2(4, 2);
  ivec2 corner = ray / block * block;
  ivec2 first = corner * pixels / rays;
  ivec2 count = (corner + block) * pixels / rays - first;
  uvec2 hash = HashOf(corner);
  ivec2 most = count / block;
  ivec2 apart = most - ivec2(hash & 1023u) % (most / 2 + 1);
  ivec2 starts = count - (block - 1) * apart;
  return first + ivec2((hash >> 10u) & 65535u) % starts + (ray - corner) * apart;
}
