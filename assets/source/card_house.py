"""The house of forty cards of PEEL and Box2D, which the hard case H15 and the peer scene `cards` both build."""

SIZE_M = (0.002, 0.4, 0.3)  # of a card: across, up, deep


def card_house():
    """Yields each card's centre (x, y in m) and its angle about z in degrees, in the order of building."""
    x_start, y = 0.0, 0.2 - 0.02
    for pairs in range(5, 0, -1):
        x = x_start
        for i in range(pairs):
            if i < pairs - 1:
                yield x + 0.25, y + 0.2 - 0.015, 90
            yield x, y, -25
            yield x + 0.175, y, 25
            x += 0.35
        y += 0.4 - 0.03
        x_start += 0.175
