// The page's colours for drawing on a canvas.

/** The colours of the page as numbers, whatever way the style sheet writes them. */
export function coloursOf(element) {
  const style = getComputedStyle(element);
  const brush = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  const number = (name) => {
    brush.fillStyle = '#888888';
    brush.fillStyle = style.getPropertyValue(name).trim();
    brush.fillRect(0, 0, 1, 1);
    const [r, g, b] = brush.getImageData(0, 0, 1, 1).data;
    return (r << 16) | (g << 8) | b;
  };
  const background = number('--panel');
  return {
    background,
    human: number('--human'),
    avatar: number('--avatar'),
    act: number('--act'),
    ghost: number('--ghost'),
    cursor: number('--cursor'),
    dark: (background >> 16) + ((background >> 8) & 255) + (background & 255) < 384,
  };
}
