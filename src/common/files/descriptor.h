#pragma once

namespace crowd {

/// @brief An open file of the operating system; the destructor closes it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }
  /// @brief Closes it if it is open. Returns whether there was no error; else errno has the reason.
  bool close();

 private:
  int number_;
};

}  // namespace crowd
