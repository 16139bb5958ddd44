#include "core/formats/tensor_file.h"

#include <bit>
#include <cassert>
#include <numeric>
#include <type_traits>

namespace nacre {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::size_t alignment = 8;  // bytes
constexpr std::uint8_t type_u8 = 1, type_f32 = 10;

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string_view bytes_of(const Tensor& tensor) {
    return std::visit(
        [&]<class T>(const std::vector<T>& values) {
            assert(values.size() == std::accumulate(tensor.shape.begin(), tensor.shape.end(), std::size_t{1},
                                                    std::multiplies<>()));
            return std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        },
        tensor.values);
}

std::size_t entry_size(const Tensor& tensor) {
    return 2 + tensor.name.size() + 2 + 1 + 8 + 8 * tensor.shape.size();
}

std::size_t aligned(std::size_t offset) { return (offset + alignment - 1) / alignment * alignment; }

}  // namespace

std::string tensor_file(std::span<const Tensor> tensors) {
    std::string bytes("tensor_file\0", 12);
    append(bytes, std::uint8_t{1});
    append(bytes, std::uint8_t{0});
    append(bytes, static_cast<std::uint32_t>(tensors.size()));
    std::size_t offset = bytes.size();
    for (const Tensor& tensor : tensors) offset += entry_size(tensor);
    for (const Tensor& tensor : tensors) {
        offset = aligned(offset);
        append(bytes, static_cast<std::uint16_t>(tensor.name.size()));
        bytes += tensor.name;
        append(bytes, static_cast<std::uint16_t>(tensor.shape.size()));
        append(bytes, std::holds_alternative<std::vector<float>>(tensor.values) ? type_f32 : type_u8);
        append(bytes, static_cast<std::uint64_t>(offset));
        for (const std::size_t size : tensor.shape) append(bytes, static_cast<std::uint64_t>(size));
        offset += bytes_of(tensor).size();
    }
    for (const Tensor& tensor : tensors) {
        bytes.resize(aligned(bytes.size()), '\0');
        bytes += bytes_of(tensor);
    }
    return bytes;
}

}  // namespace nacre
