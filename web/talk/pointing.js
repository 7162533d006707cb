// Turns mouse, finger and keys on the scene or the map into events: samples while the pointer moves, a stroke for a click,
// a hold for a press that lasts or moves. Knows no picture: `at(x, y)` of the surface gives the point of the table.

const sample_ms = 1000 / 30;
const rest_ms = 400; // a mouse that rests longer than this does not point
const hold_ms = 350;
const drag_px = 8;

const point = (phase, target) => ({kind: 'gesture', name: 'point', hand: 'right', phase, ...(target && {target})});

export class Pointing {
  #send;
  #sample;
  #shown;
  #keeps;
  #target = null; // where it points, [x, y]
  #moved_at = -Infinity;
  #press = null; // {id, x, y, target, held}
  #timer = 0;
  #hold_timer = 0;

  /**
   * `send(event)`, `sample(event)`; `shown(target)`: where the human points now, or null; `keeps(target)`: takes a click that
   * goes with what is being typed, and says whether it did; asked with null it only tells whether it would.
   */
  constructor({send, sample, shown, keeps}) {
    Object.assign(this, {enabled: true});
    this.#send = send;
    this.#sample = sample;
    this.#shown = shown;
    this.#keeps = keeps;
  }

  /** Takes what happens on this element. */
  listen(element, at) {
    const where = ({clientX, clientY}) => at(clientX, clientY);
    element.addEventListener('pointermove', (event) => this.#move(event, where(event)));
    element.addEventListener('pointerdown', (event) => this.#down(event, where(event), element));
    element.addEventListener('pointerup', (event) => this.#up(event));
    element.addEventListener('pointercancel', (event) => this.#cancel(event));
    element.addEventListener('pointerleave', () => {
      if (!this.#press) this.#show(null);
    });
    // Whoever points while typing goes on typing.
    element.addEventListener('mousedown', (event) => event.preventDefault());
    element.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  #show(target) {
    this.#target = target;
    this.#shown(target);
  }

  #move(event, target) {
    if (!this.enabled) return;
    if (this.#press && event.pointerId !== this.#press.id) return;
    // Turning the view is no pointing.
    if (!this.#press && (event.buttons || event.pointerType === 'touch')) return;
    this.#show(target ?? (this.#press?.held ? this.#target : null));
    this.#moved_at = performance.now();
    if (this.#press && Math.hypot(event.clientX - this.#press.x, event.clientY - this.#press.y) > drag_px) this.#hold();
    this.#run();
  }

  #down(event, target, element) {
    if (!this.enabled) return;
    if (this.#press) {
      this.#cancel({pointerId: this.#press.id});
      return;
    } // a second finger: the view is being turned
    if (event.button !== 0 || event.shiftKey || !target) return;
    element.setPointerCapture?.(event.pointerId);
    this.#press = {
      id: event.pointerId,
      x: event.clientX,
      y: event.clientY,
      target,
      held: false,
      touch: event.pointerType === 'touch',
    };
    this.#show(target);
    this.#hold_timer = setTimeout(() => this.#hold(), hold_ms);
  }

  #hold() {
    clearTimeout(this.#hold_timer);
    if (!this.#press || this.#press.held || this.#keeps(null)) return;
    this.#press.held = true;
    this.#send(point('start', this.#press.target));
    this.#run();
  }

  #up(event) {
    const press = this.#press;
    if (!press || event.pointerId !== press.id) return;
    this.#release();
    if (press.held) this.#send(point('stop'));
    else this.stroke(press.target);
  }
  #cancel(event) {
    const press = this.#press;
    if (!press || event.pointerId !== press.id) return;
    this.#release();
    if (press.held) this.#send(point('stop'));
  }
  #release() {
    clearTimeout(this.#hold_timer);
    this.#moved_at = -Infinity;
    if (this.#press.touch) this.#show(null);
    this.#press = null;
  }

  /** A click, or Enter on the cross. */
  stroke(target) {
    if (this.enabled && !this.#keeps(target)) this.#send(point('stroke', target));
  }

  /** Samples until there is nothing to point at any more. */
  #run() {
    if (this.#timer) return;
    this.#timer = setInterval(() => {
      const pointing = this.#press ? this.#press.held : performance.now() - this.#moved_at < rest_ms;
      if (!pointing || !this.#target) {
        this.stop();
        return;
      }
      if (!this.#keeps(null)) this.#sample({kind: 'pointing', hand: 'right', target: this.#target});
    }, sample_ms);
  }
  stop() {
    clearInterval(this.#timer);
    this.#timer = 0;
  }
  close() {
    this.enabled = false;
    this.stop();
    clearTimeout(this.#hold_timer);
  }
}
