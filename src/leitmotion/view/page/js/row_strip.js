// The strip: postures at their times, chosen by the library, as many as have 78 px each.

const STRIP_APART = 78;

(() => {
  const canvas = document.createElement("canvas");
  const element = make("div", "row strip", canvas, { "aria-hidden": "true" });
  seekable(element);
  timeRows.push({
    order: 10,
    element,
    layout(width) {
      const height = element.clientHeight;
      const pen = sized(canvas, timeline.element.clientWidth, height);
      const fits = strips.filter((frames) => {
        for (let k = 1; k < frames.length; k++) if (across((frames[k] - frames[k - 1]) / clip.rate) < STRIP_APART) return false;
        return frames.length > 0;
      });
      const frames = fits.length ? fits.reduce((a, b) => (b.length > a.length ? b : a)) : strips[0] || [];
      element.dataset.times = Array.from(frames, (f) => (f / clip.rate).toFixed(2)).join(" ");
      for (const frame of frames) {
        const time = frame / clip.rate;
        drawSmall(pen, time, { x: timeline.left + across(time), base: height - 4, height: height - 11, width: STRIP_APART - 8, row: true });
      }
    },
  });
})();
