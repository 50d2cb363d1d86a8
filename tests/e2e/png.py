"""Images as rows of (r, g, b): 8-bit RGB, as the program writes them."""
import ctypes
import pathlib

libpng = ctypes.CDLL("libpng16.so.16")
VERSION, RGB = 1, 2  # PNG_IMAGE_VERSION, PNG_FORMAT_RGB


class Image(ctypes.Structure):  # png_image of libpng's simplified interface
    _fields_ = [("opaque", ctypes.c_void_p), ("version", ctypes.c_uint32), ("width", ctypes.c_uint32),
                ("height", ctypes.c_uint32), ("format", ctypes.c_uint32), ("flags", ctypes.c_uint32),
                ("colormap_entries", ctypes.c_uint32), ("warning_or_error", ctypes.c_uint32), ("message", ctypes.c_char * 64)]


def read_png(file):
    data = pathlib.Path(file).read_bytes()
    image = Image(version=VERSION)
    read = libpng.png_image_begin_read_from_memory(ctypes.byref(image), data, ctypes.c_size_t(len(data)))
    assert read and image.format == RGB, (file, image.message, image.format)
    stride = 3 * image.width
    pixels = ctypes.create_string_buffer(stride * image.height)
    read = libpng.png_image_finish_read(ctypes.byref(image), None, pixels, 0, None)
    assert read, (file, image.message)
    raw = pixels.raw
    return [list(zip(*[iter(raw[y * stride:(y + 1) * stride])] * 3)) for y in range(image.height)]
