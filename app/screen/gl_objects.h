// OpenGL objects, owned. Uses only the part of OpenGL 2.1 that OpenGL ES 2.0 has too (buffers,
// shaders, textures), so that small computers and software drawing run it alike.
// Threads: the one that holds the context; objects must die before the context.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace touchline {

/// The name of an OpenGL object, deleted with its owner.
template <void (*destroy)(std::uint32_t)>
class GlName {
  public:
    explicit GlName(std::uint32_t name = 0) : name_(name) {}

    GlName(GlName&& other) noexcept : name_(other.name_) { other.name_ = 0; }

    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    ~GlName() {
        if (name_ != 0) destroy(name_);
    }

    [[nodiscard]] std::uint32_t get() const { return name_; }

  private:
    std::uint32_t name_;
};

void destroy_program(std::uint32_t name);
void destroy_buffer(std::uint32_t name);
void destroy_texture(std::uint32_t name);

using GlProgram = GlName<destroy_program>;
using GlBuffer = GlName<destroy_buffer>;
using GlTexture = GlName<destroy_texture>;

/// Compiles and links; attribute i of `attributes` gets place i. Fails with the driver's words.
[[nodiscard]] Result<GlProgram> make_program(const char* vertex_source, const char* fragment_source,
                                             std::initializer_list<const char*> attributes);

[[nodiscard]] GlBuffer make_buffer();
[[nodiscard]] GlTexture make_texture();

/// One vertex attribute of floats or normalised bytes, `offset` bytes into each vertex.
struct VertexAttribute {
    int count = 0;
    bool is_bytes = false;
    std::size_t offset = 0;
};

/// Binds the buffer's vertices of `stride` bytes to attributes 0, 1, ...
void bind_vertices(const GlBuffer& buffer, std::size_t stride,
                   std::initializer_list<VertexAttribute> attributes);

}  // namespace touchline
