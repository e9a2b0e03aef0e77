// An OpenGL object owned by one value: deleted when its owner goes.
#pragma once

#include <utility>

namespace renderer::gpu {

/// Holds an object's name and the way to delete it.  Movable, not copyable; the context that made
/// the object has to be current when it is deleted.
class Object {
  public:
    using Destroy = void (*)(unsigned name);

    Object(unsigned name, Destroy destroy) : name_(name), destroy_(destroy) {}

    Object(Object&& other) noexcept
        : name_(std::exchange(other.name_, 0)), destroy_(other.destroy_) {}

    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(destroy_, other.destroy_);
        return *this;
    }

    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    ~Object() {
        if (name_ != 0)
            destroy_(name_);
    }

    unsigned name() const { return name_; }

  private:
    unsigned name_;
    Destroy destroy_;
};

} // namespace renderer::gpu
